// The live figures of a page: settings and calls that stand in their tags.
import '../element.js';

for (const fur of document.querySelectorAll('wet-fur')) {
  Object.assign(fur.settings, JSON.parse(fur.dataset.set ?? '{}'));
  const calls = JSON.parse(fur.dataset.call ?? '[]');
  if (calls.length === 0) continue;
  fur.addEventListener('load', () => {
    for (const [method, ...given] of calls) fur[method](...given);
  }, { once: true });
}
