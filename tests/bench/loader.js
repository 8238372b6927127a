// ?page=limit, fur or hair
const name = new URLSearchParams(location.search).get('page');
await import(`./${name}.js`);
