// In Docusaurus: a client module (`clientModules` in docusaurus.config.js).
import 'wet-fur/companions';
import 'wet-fur/element';
