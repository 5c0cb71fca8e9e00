/** What is not in sight is not drawn: it is drawn when its panel, its drawer or its part of the page is shown. */

/** What hides all within it. */
const HIDING = '[hidden], .is-closed';

export function isHidden(element: Element): boolean {
  return element.closest(HIDING) !== null;
}

/** Draws at each call while `host` is in sight; what was not drawn is drawn when it comes into sight, before the browser paints. */
export function whenInSight(host: Element, draw: () => void): () => void {
  let due = false;
  const observer = new MutationObserver(() => {
    if (!isHidden(host)) show();
  });
  function show(): void {
    observer.disconnect();
    due = false;
    draw();
  }
  return () => {
    if (!isHidden(host)) return show();
    if (due) return;
    due = true;
    for (let around: Element | null = host; around !== null; around = around.parentElement)
      observer.observe(around, { attributes: true, attributeFilter: ['hidden', 'class'] });
  };
}
