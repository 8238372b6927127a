// wet-fur/companions: registers the elements that go with <wet-fur> in a text.
import type { WetFurElement } from './element.js';

/**
 * What they have in common. `for` names the id of a <wet-fur>; without it, it is the nearest one. The figure may come, go and be
 * exchanged at any time. What is wrong with the tag, or goes wrong, stands in the element as text (part `error`).
 */
export class Companion extends HTMLElement {
  /** The <wet-fur> that it is about; null while there is none. */
  readonly figure: WetFurElement | null;
  /** What it is called; by default as the settings table has it. */
  label: string;
}

/** A range for a number of the figure; without `setting` a number of its own. Events `input` and `change`. */
export class WetFurSliderElement extends Companion {
  setting: string;
  value: number;
}

/** One of several values: buttons, a list, a tick or a colour. With `method` each is what that is called with. Event `change`. */
export class WetFurChoiceElement extends Companion {
  setting: string;
  method: string;
  get value(): string | boolean | undefined;
  set value(value: string | boolean | number);
}

/** Calls a method of the figure, once that shows a model. */
export class WetFurButtonElement extends Companion {
  method: string;
}

/** A value of the figure as text. */
export class WetFurReadoutElement extends Companion {
  /** The name of a setting, `wetness`, a member of `stats`, `action`, `state` or `modelName`. */
  value: string;
}

/** Before and after: two figures inside it, or two states of the one that `for` names. Events `divide` and `picture-change`. */
export class WetFurCompareElement extends Companion {
  /** Percent of the width that shows what was before. */
  position: number;
}

/** Steps of a text that a figure follows. Event `step-change`. */
export class WetFurStepsElement extends Companion {
  /** The step that is read now, from 0; -1 before the first. */
  readonly current: number;
}

/** Curves of functions of core.equations. */
export class WetFurPlotElement extends Companion {}

declare global {
  interface HTMLElementTagNameMap {
    'wet-fur-slider': WetFurSliderElement;
    'wet-fur-choice': WetFurChoiceElement;
    'wet-fur-button': WetFurButtonElement;
    'wet-fur-readout': WetFurReadoutElement;
    'wet-fur-compare': WetFurCompareElement;
    'wet-fur-steps': WetFurStepsElement;
    'wet-fur-plot': WetFurPlotElement;
  }
}
