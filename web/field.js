// Rows of the settings table.

/** A row of the table as people want it: the options as a list, bounds only where they mean something. */
export function readableField({ options, min, max, ...field }) {
  if (field.type === 'choice') return Object.freeze({ ...field, options: Object.freeze(options.split('|')) });
  return Object.freeze(field.type === 'float' || field.type === 'int' ? { ...field, min, max } : field);
}
