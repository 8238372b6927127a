// What Vue's checker makes of our tags in a strict template; tsc reads it, nothing runs it.
import type { GlobalComponents } from 'vue';
import type {} from 'wet-fur/vue';

type Props<Tag extends keyof GlobalComponents> = GlobalComponents[Tag] extends new () => { $props: infer Given } ? Given : never;

export const figure: Props<'wet-fur'> = {
  id: 'fig', class: 'wide', src: 'otter', tool: 'droplet', 'camera-controls': true,
  'onWetness-change': ({ detail }) => console.log(detail.wetness.toFixed(2)),
};
export const slider: Props<'wet-fur-slider'> = { for: 'fig', setting: 'curl', max: 1 };
// @ts-expect-error there is no such tool
export const hammer: Props<'wet-fur'> = { tool: 'hammer' };
// @ts-expect-error nor such an attribute
export const strange: Props<'wet-fur-slider'> = { of: 'fig' };
