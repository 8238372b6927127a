/**
 * Registers the elements that go with <wet-fur> in a text: `<wet-fur-slider for="fig" setting="curl"></wet-fur-slider>` and
 * <wet-fur-choice>, <wet-fur-button>, <wet-fur-readout>, <wet-fur-compare>, <wet-fur-steps>, <wet-fur-plot>.
 */
import { WetFurButtonElement } from './companions/button.js';
import { WetFurChoiceElement } from './companions/choice.js';
import { Companion, define } from './companions/companion.js';
import { WetFurCompareElement } from './companions/compare.js';
import { WetFurPlotElement } from './companions/plot.js';
import { WetFurReadoutElement } from './companions/readout.js';
import { WetFurSliderElement } from './companions/slider.js';
import { WetFurStepsElement } from './companions/steps.js';

export {
  Companion, WetFurButtonElement, WetFurChoiceElement, WetFurCompareElement, WetFurPlotElement, WetFurReadoutElement, WetFurSliderElement, WetFurStepsElement,
};

define('wet-fur-slider', WetFurSliderElement);
define('wet-fur-choice', WetFurChoiceElement);
define('wet-fur-button', WetFurButtonElement);
define('wet-fur-readout', WetFurReadoutElement);
define('wet-fur-compare', WetFurCompareElement);
define('wet-fur-steps', WetFurStepsElement);
define('wet-fur-plot', WetFurPlotElement);
