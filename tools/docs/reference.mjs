// The tables of the reference, made of what the program itself is made of.
export function addReference(config, tools) { void config; void tools; }
