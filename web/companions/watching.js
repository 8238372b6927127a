// Which figure a companion is about: `for` names its id, in the companion's own tree or in one that holds it; without `for` it is
// the one nearest to it. Pages put figures in, take them out and exchange them at any time; one observer a tree sees that.

/** Companions by the tree that is observed for them. */
const watchers = new Map();

/** The companion's own tree, then that of the element whose shadow holds it, and so on up to the document. */
function treesOf(companion) {
  const trees = [];
  for (let tree = companion.getRootNode(); tree; tree = tree.host?.getRootNode()) trees.push(tree);
  return trees;
}

/** @returns {Element | null} what `for` names, else the nearest <wet-fur> */
export function findFigure(companion) {
  const id = companion.getAttribute('for');
  for (const tree of treesOf(companion)) {
    if (id) {
      const named = tree.getElementById?.(id);
      if (named) return named;
      continue;
    }
    for (let place = companion; place; place = place.parentNode) {
      const near = place.querySelector?.('wet-fur');
      if (near) return near;
    }
  }
  return null;
}

function observe(tree) {
  const companions = new Set();
  const observer = new MutationObserver(() => companions.forEach((companion) => companion.look()));
  observer.observe(tree, { childList: true, subtree: true, attributeFilter: ['id'] });
  const watcher = { companions, observer };
  watchers.set(tree, watcher);
  return watcher;
}

/** From now on its look() is called whenever the page around it has changed. */
export function watch(companion) {
  for (const tree of treesOf(companion)) (watchers.get(tree) ?? observe(tree)).companions.add(companion);
}

export function unwatch(companion) {
  for (const [tree, { companions, observer }] of watchers) {
    companions.delete(companion);
    if (companions.size > 0) continue;
    observer.disconnect();
    watchers.delete(tree);
  }
}
