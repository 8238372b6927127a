// wet-fur/react: `import type {} from 'wet-fur/react'` makes our tags known to JSX, of React 18 and 19 and of all that has its namespace JSX.
// In React 18 an attribute is there when it has any value but null and undefined: write `camera-controls=""`.
import type { DetailedHTMLProps, HTMLAttributes } from 'react';
import type { WetFurTags } from './attributes.js';
import type {} from './companions.js';
import type { WetFurElementEventMap } from './element.js';

/** React 19 listens: `onwetness-change={(event) => …}`. */
type Listeners<Events> = { [Type in keyof Events & string as `on${Type}`]?: (event: Events[Type]) => void };
type Tag<Name extends keyof WetFurTags & keyof HTMLElementTagNameMap> =
  DetailedHTMLProps<HTMLAttributes<HTMLElementTagNameMap[Name]>, HTMLElementTagNameMap[Name]> & WetFurTags[Name];
type WetFurJsx = { [Name in keyof WetFurTags]: Tag<Name> & (Name extends 'wet-fur' ? Listeners<WetFurElementEventMap> : unknown) };

declare module 'react' {
  namespace JSX {
    interface IntrinsicElements extends WetFurJsx {}
  }
}
declare global {
  namespace JSX {
    interface IntrinsicElements extends WetFurJsx {}
  }
}
