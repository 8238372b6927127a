// What a strict user of React writes; tsc reads it, nothing runs it.
import { useRef } from 'react';
import type {} from 'wet-fur/react';
import type { WetFurElement } from 'wet-fur/element';

export function Figure() {
  const fur = useRef<WetFurElement>(null);
  return (
    <figure onClick={() => fur.current?.shake()}>
      <wet-fur ref={fur} id="fig" className="wide" src="otter" preset="wool" tool="droplet" camera-controls dry-rate={0.1} view="final"
        onwetness-change={({ detail }) => console.log(detail.wetness.toFixed(2))}></wet-fur>
      <wet-fur-slider for="fig" setting="curl" min={0} max="1"></wet-fur-slider>
      <wet-fur-choice for="fig" setting="view" values="final, skin"></wet-fur-choice>
      <wet-fur-button for="fig" method="shake">Shake</wet-fur-button>
      <wet-fur-readout for="fig" value="wetness" digits={1}></wet-fur-readout>
      <wet-fur-compare for="fig" before='{"view":"skin"}' after="{}" position={40}></wet-fur-compare>
      <wet-fur-steps for="fig"><section data-set="{}">One</section></wet-fur-steps>
      <wet-fur-plot x="h" equations="[]" parameters="{}"></wet-fur-plot>
      {/* @ts-expect-error there is no such tool */}
      <wet-fur tool="hammer"></wet-fur>
      {/* @ts-expect-error nor such an attribute */}
      <wet-fur-slider of="fig"></wet-fur-slider>
    </figure>
  );
}
