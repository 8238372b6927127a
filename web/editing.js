// The editor's program: the scene moves over to it and back, and work that the viewer's program leaves to it.
import { asFurError, FurError } from './errors.js';
import { FurApp } from './furapp.js';
import { instantiateProgram } from './runtime.js';

export class Editing {
  #session;
  #frames;
  #loading;
  #host;
  #switching = Promise.resolve();

  /**
   * @param {import('./session.js').Session} session
   * @param {{ frames: import('./frames.js').Frames, loading: import('./loading.js').Loading, host: import('./host.js').WetFur, openDialog: () => void }} parts
   */
  constructor(session, { frames, loading, host, openDialog }) {
    this.#session = session;
    this.#frames = frames;
    this.#loading = loading;
    this.#host = { fur: host, wake: () => frames.wake(), openDialog };
  }

  /** Resolves when it is open or closed; what goes wrong is told as an error. */
  open(open) {
    const session = this.#session;
    session.options.editor = open;
    this.#switching = this.#switching.then(() => this.#moveTo(open ? 'editor' : this.#session.needsLarger || this.#session.app?.haired ? 'hair' : 'viewer'))
      .catch((error) => {
        session.options.editor = session.panel !== null;
        const known = asFurError(error, 'wasm-load');
        session.emit('error', { code: known.code, message: known.message });
      });
    return this.#switching;
  }

  async #moveTo(which) {
    const session = this.#session;
    if (which === session.program || !session.loaded) return;
    const { EditorPanel } = which === 'editor' ? await import('./editor.js') : {};
    const { tool } = session.app;
    if (!await this.#loading.moveTo(which, 'editor')) return;
    session.app.tool = tool;
    if (EditorPanel) {
      const { width, height, pixelRatio } = session.screen;
      session.panel = new EditorPanel(session.app, session.canvas, this.#host);
      session.panel.resize(width, height, pixelRatio);
    }
    this.#frames.drawNow();
    await this.#loading.provideImage();
    this.#frames.drawNow();
    this.#frames.wake();
    session.tellState('editor');
  }

  #instantiate(which) {
    return instantiateProgram(which, (loaded, total) => this.#loading.progress('editor', loaded, total));
  }

  /** Work that the viewer's program leaves to the editor's: on a copy of the scene, without a picture. */
  async inWorkshop(work) {
    const { app, loaded, program } = this.#session;
    if (!loaded) throw new FurError('bad-file', 'there is no model yet');
    if (program === 'editor') return work(app);
    const copy = new FurApp(await this.#instantiate('editor'));
    try {
      copy.giveSurface(app.surface);
      this.#loading.putBack(copy, this.#loading.document);
      return await work(copy);
    } finally {
      copy.destroy();
    }
  }

  /** The same where it changes long hair. */
  async hairInWorkshop(work) {
    const done = await this.inWorkshop((app) => {
      work(app);
      return app === this.#session.app ? null : { hair: app.hair, warnings: app.takeWarnings() };
    });
    if (done) {
      await this.takeHair(done.hair, true);
      for (const warning of done.warnings) this.#session.warn(warning);
    }
    this.#frames.afterChange();
  }

  /** Long hair in place of what there is, as FurApp.hair has it; where there is some, in a program that grows it. */
  async takeHair(bytes, undoable) {
    if (bytes.byteLength) await this.#moveTo(this.#session.program === 'viewer' ? 'hair' : this.#session.program);
    this.#session.app.restoreHair(bytes, undoable);
  }

  /** The same where it changes the groom. */
  async groomInWorkshop(work) {
    await this.inWorkshop((app) => {
      work(app);
      if (app !== this.#session.app) this.#session.app.restoreGroom(app.groom, true);
    });
    this.#frames.afterChange();
  }
}
