// Pages that the tests of a file use one after the other. One that was used before opens in a third of the time: its process is
// there and has the program compiled. What a test leaves in it is taken away: documents, storage, routes, listeners, permissions.

/** Pages without a use that are kept; each takes memory. */
const most = 4;
/** What tests listen to. */
const events = ['console', 'dialog', 'download', 'pageerror', 'popup', 'request', 'response'];

const textOf = (script) => (typeof script === 'string' ? script : `(${script})()`);

export class Pages {
  #browser;
  #origin;
  #idle = [];

  /** `origin`: of the site whose pages these are. */
  constructor(browser, origin) {
    this.#browser = browser;
    this.#origin = origin;
  }

  /** A page as new, the first of its context, whose options are given; `scripts` run before those of each document. */
  async take({ viewport, colorScheme = 'light', reducedMotion = 'no-preference', permissions = [], scripts = [], ...fixed }) {
    const texts = scripts.map(textOf);
    const kind = JSON.stringify([fixed, texts]);
    const at = this.#idle.findIndex((one) => one.kind === kind);
    const entry = at >= 0 ? this.#idle.splice(at, 1)[0] : await this.#make(kind, fixed, texts);
    const { page } = entry;
    page.problems = [];
    page.on('pageerror', (error) => page.problems.push(`uncaught: ${error.message}`));
    page.on('console', (message) => { if (message.type() === 'error') page.problems.push(`console: ${message.text()}`); });
    await Promise.all([page.setViewportSize(viewport), page.emulateMedia({ colorScheme, reducedMotion }), page.context().grantPermissions(permissions)]);
    return entry;
  }

  async #make(kind, fixed, texts) {
    const context = await this.#browser.newContext(fixed);
    for (const content of texts) await context.addInitScript({ content });
    const page = await context.newPage();
    return { kind, context, page, session: await context.newCDPSession(page) };
  }

  /** Closes it for good. */
  async close({ context }) {
    // What a test answers itself may still be asked for.
    await Promise.all(context.pages().map((page) => page.unrouteAll({ behavior: 'ignoreErrors' })));
    await context.close();
  }

  /** Takes back a page that is to be as new for another test. */
  async giveBack(entry) {
    if (entry.page.isClosed()) return this.close(entry);
    await this.#tidy(entry);
    this.#idle.push(entry);
    if (this.#idle.length > most) await this.close(this.#idle.shift());
  }

  async #tidy({ context, page, session }) {
    await Promise.all(context.pages().filter((other) => other !== page).map((other) => other.close()));
    for (const event of events) page.removeAllListeners(event);
    await page.unrouteAll({ behavior: 'ignoreErrors' });
    await page.mouse.move(-1, -1);
    await page.evaluate(() => {
      sessionStorage.clear();
      Storage.prototype.setItem = () => {};  // nor does the page write as it is left
    });
    await page.goto('about:blank');
    await session.send('Storage.clearDataForOrigin', { origin: this.#origin, storageTypes: 'all' });
    await context.clearPermissions();
  }
}
