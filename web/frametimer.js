// How long the graphics processor takes for a frame, where EXT_disjoint_timer_query_webgl2 tells.

const mostPending = 8;

export class FrameTimer {
  #gl;
  #extension;
  #pending = [];
  #open = false;

  /** Milliseconds of the newest frame that is known; 0: none is. */
  milliseconds = 0;

  constructor(gl) {
    this.#gl = gl;
    this.#extension = gl.getExtension('EXT_disjoint_timer_query_webgl2');
  }

  /** Draws between the two are measured. */
  begin() {
    if (!this.#extension || this.#pending.length >= mostPending) return;
    const query = this.#gl.createQuery();
    this.#gl.beginQuery(this.#extension.TIME_ELAPSED_EXT, query);
    this.#pending.push(query);
    this.#open = true;
  }
  end() {
    if (!this.#open) return;
    this.#gl.endQuery(this.#extension.TIME_ELAPSED_EXT);
    this.#open = false;
  }

  dispose() { for (const query of this.#pending.splice(0)) this.#gl.deleteQuery(query); }

  /** Takes in what has become known since. */
  update() {
    const gl = this.#gl;
    while (this.#pending.length > 0 && gl.getQueryParameter(this.#pending[0], gl.QUERY_RESULT_AVAILABLE)) {
      const query = this.#pending.shift();
      const disjoint = gl.getParameter(this.#extension.GPU_DISJOINT_EXT);
      if (!disjoint) this.milliseconds = gl.getQueryParameter(query, gl.QUERY_RESULT) / 1e6;
      gl.deleteQuery(query);
    }
  }
}
