// With `export { default } from 'vitepress/theme'` in a site of yours: this recipe is built without VitePress.
import 'wet-fur/companions';
import 'wet-fur/element';
