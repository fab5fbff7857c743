// Files made in the page.

export function download(name: string, content: string | Uint8Array<ArrayBuffer>, type: string) {
  const address = URL.createObjectURL(new Blob([content], { type }));
  const link = document.createElement('a');
  link.href = address;
  link.download = name;
  link.click();
  // free the address later: the browser reads the file only after this task
  setTimeout(() => URL.revokeObjectURL(address), 10_000);
}

/** Style properties that come from the page, and that a picture needs in a file of its own. */
const STYLE = [
  'fill', 'stroke', 'stroke-width', 'stroke-dasharray', 'opacity', 'fill-opacity', 'font-size', 'font-family',
  'font-weight', 'text-anchor', 'dominant-baseline', 'paint-order', 'stroke-linejoin',
];

/** A picture as a file of its own, with the colours that it has in the page. */
export function pictureOf(svg: SVGSVGElement): string {
  const copy = svg.cloneNode(true) as SVGSVGElement;
  const originals = [svg, ...svg.querySelectorAll('*')];
  [copy, ...copy.querySelectorAll('*')].forEach((node, at) => {
    const style = getComputedStyle(originals[at]!);
    for (const name of STYLE) node.setAttribute(name, style.getPropertyValue(name));
    node.removeAttribute('class');
  });
  const ground = getComputedStyle(document.body).backgroundColor;
  const paper = document.createElementNS('http://www.w3.org/2000/svg', 'rect');
  for (const [name, value] of [['width', '100%'], ['height', '100%'], ['fill', ground]] as const) {
    paper.setAttribute(name, value);
  }
  copy.prepend(paper);
  copy.setAttribute('xmlns', 'http://www.w3.org/2000/svg');
  return new XMLSerializer().serializeToString(copy);
}
