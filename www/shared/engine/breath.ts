/** Lets the browser answer what the user did, and draw, between two pieces of work that are long together. */
export const breath = (): Promise<void> => new Promise((resolve) => setTimeout(resolve));
