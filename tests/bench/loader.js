// ?page=limit or ?page=fur
const name = new URLSearchParams(location.search).get('page');
await import(name === 'limit' ? './limit.js' : './fur.js');
