// Files that page and editor give to the person.

/** @param {BlobPart} content @returns its name */
export function download(content, name) {
  const url = URL.createObjectURL(content instanceof Blob ? content : new Blob([content]));
  Object.assign(document.createElement('a'), { href: url, download: name }).click();
  setTimeout(() => URL.revokeObjectURL(url), 10000);
  return name;
}

export const listed = (words) => new Intl.ListFormat('en-GB').format(words);

/** The whole scene as a .glb, and what it is without in words. @param {import('./element.js').WetFurElement} fur */
export async function downloadScene(fur) {
  const lost = [], prefix = 'save() leaves out ';
  const note = ({ detail }) => { if (detail.message.startsWith(prefix)) lost.push(detail.message.slice(prefix.length)); };
  fur.addEventListener('warning', note);
  try {
    const name = `${fur.modelName.replace(/\.[^.]*$/, '')}.glb`;
    download(await fur.save(), name);
    return `Saved as ${name}${lost.length > 0 ? `, without ${listed(lost)}` : ''}`;
  } finally {
    fur.removeEventListener('warning', note);
  }
}
