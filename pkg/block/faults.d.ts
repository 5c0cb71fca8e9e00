/**
 * What a call of the module ended with, where it was no refusal: memory that ran out, or a fault of the program; null for other errors. It
 * goes by the name and the message of the error, or of what `plainError` made of it: a copy that passed between workers has lost its name.
 */
export function breakdownOf(error: unknown): 'memory' | 'fault' | null;
