/** What has to be there before something can be done with what elements hold. */
const lacks = new WeakMap<Element, () => string>();

/** `lack`: empty where all is there. What is declared later comes first. */
export function declareLack(elements: readonly Element[], lack: () => string): void {
  for (const element of elements) {
    const former = lacks.get(element);
    lacks.set(element, former === undefined ? lack : () => lack() || former());
  }
}

/** What an element itself lacks; empty where nothing is known to be lacking. */
export const ownLack = (element: Element): string => lacks.get(element)?.() ?? '';
