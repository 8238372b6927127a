// wet-fur/vue: `import type {} from 'wet-fur/vue'` makes our tags known to Vue's templates.
import type { HTMLAttributes, PublicProps } from 'vue';
import type { WetFurTags } from './attributes.js';
import type {} from './companions.js';
import type { WetFurElementEventMap } from './element.js';

type Listeners<Events> = { [Type in keyof Events & string as `on${Capitalize<Type>}`]?: (event: Events[Type]) => void };
type Tag<Name extends keyof WetFurTags & keyof HTMLElementTagNameMap> = new () => {
  $props: PublicProps & HTMLAttributes & WetFurTags[Name] & (Name extends 'wet-fur' ? Listeners<WetFurElementEventMap> : unknown);
};
type WetFurComponents = { [Name in keyof WetFurTags]: Tag<Name> };

declare module 'vue' {
  interface GlobalComponents extends WetFurComponents {}
}
