// Dear ImGui's sources from the distribution's source package. apt works on lists and settings of its
// own in a temporary folder, with the addresses and keys of the system's sources; the system's
// configuration stays as it is.
import { cpSync, existsSync, mkdirSync, mkdtempSync, readFileSync, readdirSync, renameSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir, userInfo } from 'node:os';
import { dirname, join } from 'node:path';
import { Stop, run, say, which } from './process.mjs';

const byHand =
  "Put Dear ImGui's sources (imgui.h, backends/; version 1.86) into build/third_party/imgui, or name " +
  'their folder in the environment variable FUR_IMGUI_DIR.';

/**
 * The system's apt sources as deb-src stanzas and lines: { stanzas, lines }. `files` are
 * [name, text] of /etc/apt's .sources and .list files; only suites called like the release
 * (`codename`) are kept when there are any, since only the distribution itself has ImGui.
 */
export function sourceEntries(files, codename) {
  const stanzas = [];
  const lines = [];
  for (const [name, text] of files) {
    if (name.endsWith('.sources')) stanzas.push(...text.split(/\n\s*\n/).flatMap(sourceStanza));
    else lines.push(...text.split('\n').flatMap(sourceLine));
  }
  const ofRelease = (entry) => entry.suites.includes(codename);
  const keep = [...stanzas, ...lines].some(ofRelease) ? ofRelease : () => true;
  return { stanzas: stanzas.filter(keep).map((entry) => entry.text), lines: lines.filter(keep).map((entry) => entry.text) };
}

function sourceStanza(stanza) {
  const kept = stanza.split('\n').filter((line) => !line.startsWith('#'));
  const field = (name) => kept.find((line) => new RegExp(`^${name}:`, 'i').test(line))?.replace(/^[^:]*:/, '').trim();
  if (!field('Types') || /^no$/i.test(field('Enabled') ?? '')) return [];
  const text = kept.filter((line) => line.trim() && !/^Architectures:/i.test(line))
    .map((line) => (/^Types:/i.test(line) ? 'Types: deb-src' : line)).join('\n');
  return [{ text, suites: (field('Suites') ?? '').split(/\s+/) }];
}

function sourceLine(line) {
  const match = /^deb(?:-src)?\s+(\[[^\]]*\]\s+)?(\S+)\s+(\S+)\s*([^#]*)/.exec(line.trim());
  if (!match) return [];
  const options = (match[1] ?? '').replace(/\barch=\S*?(?=[\s\]])/, '');
  return [{ text: `deb-src ${options}${match[2]} ${match[3]} ${match[4]}`.trim(), suites: [match[3]] }];
}

function systemSourceFiles() {
  const files = [];
  for (const folder of ['/etc/apt', '/etc/apt/sources.list.d']) {
    for (const name of existsSync(folder) ? readdirSync(folder).sort() : []) {
      if (/\.(sources|list)$/.test(name)) files.push([name, readFileSync(join(folder, name), 'utf8')]);
    }
  }
  return files;
}

/** Unpacks the sources into `folder`. Throws Stop with what to do by hand when it cannot. */
export function fetchImgui(folder) {
  if (!which('apt-get')) throw new Stop(`Dear ImGui is missing, and there is no apt on this system. ${byHand}`);
  say("fetching Dear ImGui's sources (Debian's source package imgui)");
  const codename = /^VERSION_CODENAME=(.*)$/m.exec(readFileSync('/etc/os-release', 'utf8'))?.[1];
  const { stanzas, lines } = sourceEntries(systemSourceFiles(), codename);
  if (stanzas.length + lines.length === 0) throw new Stop(`The system names no apt sources. ${byHand}`);

  const scratch = mkdtempSync(join(tmpdir(), 'wet-fur-imgui-'));
  try {
    for (const name of ['lists/partial', 'cache/archives/partial', 'parts', 'download', 'unpacked']) {
      mkdirSync(join(scratch, name), { recursive: true });
    }
    writeFileSync(join(scratch, 'parts/system.sources'), stanzas.join('\n\n') + '\n');
    writeFileSync(join(scratch, 'parts/system.list'), lines.join('\n') + '\n');
    const own = Object.entries({
      'Dir::Etc::SourceList': '/dev/null',
      'Dir::Etc::SourceParts': join(scratch, 'parts'),
      'Dir::State::Lists': join(scratch, 'lists'),
      'Dir::Cache': join(scratch, 'cache'),
      'APT::Sandbox::User': userInfo().username,
    }).flatMap(([key, value]) => ['-o', `${key}=${value}`]);
    const here = { quiet: true, cwd: join(scratch, 'download') };
    run('apt-get', [...own, 'update'], here);
    run('apt-get', [...own, 'source', '--download-only', 'imgui'], here);
    const archive = readdirSync(here.cwd).find((name) => /^imgui_.*\.orig\.tar\./.test(name));
    if (!archive) throw new Stop('the source package imgui holds no archive');
    run('tar', ['-xf', archive, '--strip-components=1', '-C', join(scratch, 'unpacked')], here);
    install(join(scratch, 'unpacked'), folder);
  } catch (error) {
    throw error instanceof Stop ? new Stop(`Dear ImGui could not be fetched: ${error.message}\n${byHand}`) : error;
  } finally {
    rmSync(scratch, { recursive: true, force: true });
  }
}

// By way of a neighbouring name, so that an interrupted copy is not taken for the whole.
function install(from, folder) {
  const beside = `${folder}.part`;
  rmSync(beside, { recursive: true, force: true });
  mkdirSync(dirname(folder), { recursive: true });
  cpSync(from, beside, { recursive: true });
  rmSync(folder, { recursive: true, force: true });
  renameSync(beside, folder);
}
