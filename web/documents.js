// The models that undo and redo lead to, each with all that was done on it. What is farthest away goes first when they
// hold too much; the one before stays, however large.

const mostBytes = 64 * 1024 * 1024;

/**
 * @typedef {object} Document a model and what was done on it
 * @property {import('./models.js').ModelSource} source
 * @property {Uint8Array} [typeFiles] coats from files and colour maps of fur types
 * @property {boolean} [givenWater] a link brought some of the water, which no strokes tell
 * @property {string} state
 * @property {Uint8Array} groom
 * @property {Uint8Array} [hair]
 * @property {Uint8Array} water
 * @property {object} [camera] to the last digit
 * @property {Uint8Array} [history]
 */

/** What several of them share counts once. */
function bytesOf(documents) {
  const parts = documents.flatMap((one) => (one
    ? [one.groom, one.hair, one.water, one.history, one.typeFiles, one.source.bytes, ...one.source.files.values()] : []));
  return [...new Set(parts)].reduce((sum, part) => sum + (part?.byteLength ?? 0), 0);
}

export class Documents {
  #list = [null];  // null: the one on the screen
  #at = 0;

  /** Another comes after `former`, which was on the screen; what came after that can be redone no more. */
  follow(former) {
    this.#list.splice(this.#at, this.#list.length, former, null);
    this.#at += 1;
    this.#trim();
  }

  /** The one before (-1) or after (1) takes the place of `current`; undefined: it is not kept. */
  step(way, current) {
    const next = this.#list[this.#at + way];
    if (!next) return undefined;
    this.#list[this.#at] = current;
    this.#at += way;
    this.#list[this.#at] = null;
    this.#trim();
    return next;
  }

  #trim() {
    while (this.#list.length > 2 && bytesOf(this.#list) > mostBytes) {
      if (this.#at > 1 || this.#at === this.#list.length - 1) {
        this.#list.shift();
        this.#at -= 1;
      } else this.#list.pop();
    }
  }
}
