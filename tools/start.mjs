// npm start: builds the web app and serves it.
import { buildSite } from './build.mjs';
import { command } from './process.mjs';
import { serveHere } from './serve.mjs';
import { dist } from './site.mjs';

await command(async () => {
  await buildSite();
  await serveHere(dist);
});
