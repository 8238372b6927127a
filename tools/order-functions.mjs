// Puts functions of a program that are alike next to each other: node tools/order-functions.mjs program.wasm. What packs a download
// finds repetitions 32 KB back at most, and a program is twenty times as long. Nothing else changes: each function has another number.
// A program with something in it that this file does not know stays as it was.
import { readFileSync, writeFileSync } from 'node:fs';
import { pathToFileURL } from 'node:url';

const imports = 2, functions = 3, globals = 6, exported = 7, start = 8, elements = 9, code = 10;

/** What a program is read with: its bytes from `at` on. */
class Reader {
  constructor(bytes, at = 0) { Object.assign(this, { bytes, at }); }
  byte() { return this.bytes[this.at++]; }
  number() {
    let value = 0;
    for (let scale = 1, byte = 128; byte & 128; scale *= 128) value += ((byte = this.byte()) & 127) * scale;
    return value;
  }
  /** Past a number, of either sign. */
  pass() { while (this.byte() & 128); }
  skip(bytes) { this.at += bytes; }
}

function numberBytes(value) {
  const bytes = [];
  for (; value > 127; value = Math.floor(value / 128)) bytes.push((value & 127) | 128);
  return Buffer.from([...bytes, value]);
}
const withLength = (bytes) => Buffer.concat([numberBytes(bytes.length), bytes]);
const vector = (items) => Buffer.concat([numberBytes(items.length), ...items]);

class Unknown extends Error {}

/** Past the operands of one operation; those with no case have none. The number of the function that it names, or undefined. */
function passOperands(reader, operation) {
  const known = (condition) => { if (!condition) throw new Unknown(`operation ${operation}`); };
  switch (operation) {
    case 0x02: case 0x03: case 0x04: case 0x06: case 0x07: case 0x08: case 0x09: case 0x0c: case 0x0d: case 0x18:  // blocks, branches, exceptions
    case 0x20: case 0x21: case 0x22: case 0x23: case 0x24: case 0x25: case 0x26: case 0x3f: case 0x40: case 0x41: case 0x42: case 0xd0: return void reader.pass();
    case 0x0e: for (let left = reader.number(); left >= 0; left--) reader.pass(); return undefined;
    case 0x10: case 0xd2: return reader.number();
    case 0x11: reader.pass(); return void reader.pass();
    case 0x1c: return void reader.skip(reader.number());
    case 0x43: return void reader.skip(4);
    case 0x44: return void reader.skip(8);
    case 0xfc: {  // without a trap: conversions, then memory and tables
      const which = reader.number();
      known(which <= 17);
      for (let left = [2, 1, 2, 1, 2, 1, 2, 1, 1, 1][which - 8] ?? 0; left > 0; left--) reader.pass();
      return undefined;
    }
    case 0xfd: {  // four at a time
      const which = reader.number();
      if (which <= 11 || (which >= 84 && which <= 93)) reader.pass(), reader.pass();
      if (which === 12 || which === 13) reader.skip(16);
      if ((which >= 21 && which <= 34) || (which >= 84 && which <= 91)) reader.skip(1);
      return undefined;
    }
    default:
      if (operation >= 0x28 && operation <= 0x3e) return reader.pass(), void reader.pass();
      known(operation <= 0x01 || [0x05, 0x0b, 0x0f, 0x19, 0x1a, 0x1b, 0xd1].includes(operation) || (operation >= 0x45 && operation <= 0xc4));
      return undefined;
  }
}

/** Past an expression that is worked out before the program runs. */
function passConstant(reader) {
  for (let operation; (operation = reader.byte()) !== 0x0b;) if (passOperands(reader, operation) !== undefined) throw new Unknown('a function in a constant');
}

/** A function's code in pieces: bytes, and numbers of functions between them. */
function piecesOf(bytes) {
  const reader = new Reader(bytes), pieces = [];
  for (let groups = reader.number(); groups > 0; groups--) reader.pass(), reader.skip(1);  // its locals
  let from = 0;
  while (reader.at < bytes.length) {
    const operation = reader.byte(), operands = reader.at, named = passOperands(reader, operation);
    if (named === undefined) continue;
    pieces.push(bytes.subarray(from, operands), named);
    from = reader.at;
  }
  if (reader.at !== bytes.length) throw new Unknown('a function that ends within an operation');
  return [...pieces, bytes.subarray(from)];
}

/** How many functions before it one is compared with, and so many sequences more count as its own: small ones are alike by chance. */
const near = 20, ownSequences = 120;

/** Numbers of the functions, each after those that have most sequences of four bytes in common with it; `fixed`: the first of all. */
function orderOf(bodies, fixed) {
  const numbers = new Map(), sequences = bodies.map((body) => {
    const own = new Set();
    for (let at = 0; at + 4 <= body.length; at++) {
      const four = body.readUInt32LE(at);
      if (!numbers.has(four)) numbers.set(four, numbers.size);
      own.add(numbers.get(four));
    }
    return [...own];
  });
  const holders = Array.from(numbers, () => []);
  sequences.forEach((own, i) => own.forEach((sequence) => holders[sequence].push(i)));
  const seen = new Int32Array(numbers.size), common = new Int32Array(bodies.length), left = new Set(bodies.keys()), order = [];
  const take = (i) => {
    left.delete(i);
    order.push(i);
    for (const sequence of sequences[i]) if (seen[sequence]++ === 0) for (const holder of holders[sequence]) common[holder]++;
    if (order.length <= near) return;
    for (const sequence of sequences[order.at(-1 - near)]) if (--seen[sequence] === 0) for (const holder of holders[sequence]) common[holder]--;
  };
  fixed.forEach(take);
  while (left.size > 0) {
    let best = -1, most = -1;
    for (const i of left) {
      const share = common[i] / (sequences[i].length + ownSequences);
      if (share > most) most = share, best = i;
    }
    take(best);
  }
  return order;
}

/** The program with its functions in another order. Throws Unknown. */
export function ordered(program) {
  const whole = new Reader(program, 8), sections = [];
  while (whole.at < program.length) {
    const id = whole.byte(), length = whole.number();
    sections.push({ id, bytes: program.subarray(whole.at, whole.at + length) });
    whole.skip(length);
  }
  const section = (id) => sections.find((one) => one.id === id);
  const read = (id, each) => {
    const reader = new Reader(section(id)?.bytes ?? Buffer.of(0)), all = [];
    for (let left = reader.number(); left > 0; left--) all.push(each(reader));
    return all;
  };
  const slice = (reader, pass) => {
    const from = reader.at;
    pass(reader);
    return reader.bytes.subarray(from, reader.at);
  };
  const limits = (reader) => { if (reader.number() & 1) reader.pass(); reader.pass(); };
  const imported = read(imports, (reader) => {
    for (let names = 2; names > 0; names--) reader.skip(reader.number());
    const kind = reader.byte();
    [() => reader.pass(), () => (reader.skip(1), limits(reader)), () => limits(reader), () => reader.skip(2), () => (reader.skip(1), reader.pass())][kind]();
    return kind;
  }).filter((kind) => kind === 0).length;
  const types = read(functions, (reader) => slice(reader, (one) => one.pass()));
  const bodies = read(code, (reader) => slice(reader, (one) => one.skip(one.number()))).map((body) => {
    const reader = new Reader(body);
    reader.number();
    return body.subarray(reader.at);
  });
  const pieces = bodies.map(piecesOf);
  // The numbers that fit into a byte are for those that are called most.
  const calls = new Int32Array(bodies.length);
  for (const piece of pieces.flat()) if (piece >= imported) calls[piece - imported]++;
  const most = [...bodies.keys()].sort((a, b) => calls[b] - calls[a]).slice(0, Math.max(0, 128 - imported));
  const order = orderOf(bodies, most), places = new Int32Array(bodies.length);
  order.forEach((before, now) => { places[before] = now; });
  const renamed = (number) => (number < imported ? number : imported + places[number - imported]);
  const put = (id, bytes) => { if (section(id)) section(id).bytes = bytes; };

  put(functions, vector(order.map((i) => types[i])));
  put(code, vector(order.map((i) => withLength(Buffer.concat(pieces[i].map((piece) => (typeof piece === 'number' ? numberBytes(renamed(piece)) : piece)))))));
  put(exported, vector(read(exported, (reader) => {
    const name = slice(reader, (one) => one.skip(one.number())), kind = reader.byte(), number = reader.number();
    return Buffer.concat([name, Buffer.of(kind), numberBytes(kind === 0 ? renamed(number) : number)]);
  })));
  put(elements, vector(read(elements, (reader) => {
    const flags = reader.number();
    if (flags !== 0) throw new Unknown(`a table's elements of kind ${flags}`);
    const place = slice(reader, passConstant), all = [];
    for (let left = reader.number(); left > 0; left--) all.push(numberBytes(renamed(reader.number())));
    return Buffer.concat([Buffer.of(flags), place, vector(all)]);
  })));
  read(globals, (reader) => (reader.skip(2), passConstant(reader)));
  if (section(start)) put(start, numberBytes(renamed(new Reader(section(start).bytes).number())));
  for (const { id, bytes } of sections) {
    if (id > 13) throw new Unknown(`section ${id}`);
    if (id === 0 && bytes.subarray(1, 5).toString() === 'name') throw new Unknown('names of functions');
  }
  const result = Buffer.concat([program.subarray(0, 8), ...sections.map(({ id, bytes }) => Buffer.concat([Buffer.of(id), withLength(bytes)]))]);
  if (!WebAssembly.validate(result)) throw new Unknown('what makes it invalid');
  return result;
}

if (import.meta.url === pathToFileURL(process.argv[1]).href) {
  const file = process.argv[2];
  try {
    writeFileSync(file, ordered(readFileSync(file)));
  } catch (error) {
    if (!(error instanceof Unknown)) throw error;
    console.log(`wet-fur: ${file}: its functions stay in their order (${error.message})`);
  }
}
