// Child processes and the places of this tree, for the commands in this folder.
import { spawn, spawnSync } from 'node:child_process';
import { accessSync, constants, statSync } from 'node:fs';
import { availableParallelism, constants as os, setPriority } from 'node:os';
import { delimiter, dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

export const root = dirname(dirname(fileURLToPath(import.meta.url)));
export const jobs = Number(process.env.FUR_JOBS) || availableParallelism();

/** What a person must do before the command can go on; printed without a stack. */
export class Stop extends Error {}

export function say(text) {
  console.log(`wet-fur: ${text}`);
}

/** The full path of a program on PATH, or undefined. */
export function which(program) {
  for (const folder of (process.env.PATH ?? '').split(delimiter)) {
    const path = join(folder || '.', program);
    try {
      accessSync(path, constants.X_OK);
      if (statSync(path).isFile()) return path;
    } catch {
      // not here
    }
  }
  return undefined;
}

/**
 * Runs a program to its end with our own output, in the tree's root. `quiet` keeps its output and
 * shows it only when it fails. Returns what it kept of the
 * standard output. Throws Stop when it fails.
 */
export function run(program, args, { quiet = false, env = {}, cwd = root } = {}) {
  const result = spawnSync(program, args, {
    cwd,
    env: { ...process.env, ...env },
    stdio: quiet ? ['ignore', 'pipe', 'pipe'] : ['ignore', 'inherit', 'inherit'],
    encoding: 'utf8',
    maxBuffer: 1 << 28,
  });
  if (result.status === 0) return result.stdout;
  if (quiet) process.stderr.write(`${result.stdout ?? ''}${result.stderr ?? ''}`);
  const how = result.error ? result.error.message : `exit ${result.status ?? result.signal}`;
  throw new Stop(`${program} ${args.join(' ')}: ${how}`);
}

/**
 * Runs a program, passing its output on as it comes; gives { status, output } and never throws. `aside`: what else runs goes
 * first, and the output is only gathered.
 */
export function runGathering(program, args, { env = {}, cwd = root, aside = false } = {}) {
  return new Promise((done) => {
    const child = spawn(program, args, { cwd, env: { ...process.env, ...env }, stdio: ['ignore', 'pipe', 'pipe'] });
    if (aside && child.pid) setPriority(child.pid, os.priority.PRIORITY_LOW);
    let output = '';
    for (const [stream, ours] of [[child.stdout, process.stdout], [child.stderr, process.stderr]]) {
      stream.setEncoding('utf8');
      stream.on('data', (text) => {
        output += text;
        if (!aside) ours.write(text);
      });
    }
    child.on('error', (error) => done({ status: 127, output: `${output}\n${error.message}` }));
    child.on('close', (code, signal) => done({ status: code ?? `signal ${signal}`, output }));
  });
}

/** Runs a command's main function; its failure is one line and exit status 1. */
export async function command(main) {
  try {
    await main();
  } catch (error) {
    if (!(error instanceof Stop)) throw error;
    console.error(`wet-fur: ${error.message}`);
    process.exitCode = 1;
  }
}
