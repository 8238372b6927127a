// Mouths that open. A solid is sculpted with its jaw let down, so that there is a mouth within; then the jaw is shut again.
import { both, turnedAbout, union } from './sculpt.mjs';
import { smooth } from './vectors.mjs';

const radians = Math.PI / 180;

/**
 * `shut`: a solid, `front` the same where its mouth is; `over(p)`: how far a place is above the line of its mouth; `ahead(p)`: how far before the corners; `hinge`: a place between
 * these; `degrees`: how far it is opened; `soft`: how far skin round the corners gives; `tongue`, `palate`: solids that are added to the jaw and cut
 * out above it.
 * `open`: the solid with its mouth open; `closed(p)`, `closedWay(p, n)`: where a place of that is when it is shut, and a direction there; `mouth`: a
 * field below 0 behind the lips; `onJaw(p)`.
 */
export function jawed(shut, { front, over, ahead, hinge, degrees, soft, lip, tongue, palate }) {
  const give = (p) => smooth(0, -soft, over(p)), far = (p) => smooth(-2 * soft, soft, ahead(p));
  const share = (p) => far(p) * (give(p) + (1 - give(p)) * smooth(0, soft, ahead(p)));
  const back = (p, s) => turnedAbout(0, p, hinge, degrees * s * radians);
  const half = Math.tan(0.5 * degrees * radians);
  const onJaw = (p) => ahead(p) > -2 * soft && over(p) < (ahead(p) > 0 ? -half * ahead(p) : 0);
  const turnOf = (p) => (onJaw(p) ? share(p) : 0);
  const upper = (p) => both(both(front(p), -over(p), lip), -palate(p), lip);
  const lower = (p) => {
    const q = back(p, share(p));
    return union(both(front(q), over(q), lip), tongue(q), lip);
  };
  return {
    hinge, degrees,
    open: (p) => {
      if (ahead(p) > 0) return Math.min(upper(p), lower(p));
      const s = turnOf(p);
      return shut(s > 0 ? back(p, s) : p);
    },
    closed: (p) => back(p, turnOf(p)),
    closedWay: (p, n) => turnedAbout(0, n, [0, 0, 0], degrees * turnOf(p) * radians),
    mouth: (p) => (ahead(p) > 0 ? front(onJaw(p) ? back(p, share(p)) : p) + lip : 1),
    onJaw: (p) => ahead(p) > 0 && onJaw(p),
  };
}
