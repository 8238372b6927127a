// How far loading has come, over all its stages. Program and model arrive side by side, then the fur grows.

/** In tenths. */
const shares = { program: 6, model: 3, fur: 1 };

export class Progress {
  #done = { program: 0, model: 0, fur: 0 };

  /** 0..1, never less than before. An unknown total (0) creeps towards its end. */
  fraction(stage, loaded, total) {
    const share = total > 0 ? Math.min(1, loaded / total) : 1 - Math.exp(-loaded / 5e5);
    if (!(stage in shares)) return share;
    if (stage === 'fur') this.#done.program = this.#done.model = 1;
    this.#done[stage] = Math.max(this.#done[stage], share);
    return Object.entries(shares).reduce((sum, [name, weight]) => sum + weight * this.#done[name], 0) / 10;
  }
}
