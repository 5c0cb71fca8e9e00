/**
 * What a call of the module ended with, where it was no refusal: memory that ran out, or a fault of the program; null for other errors. It
 * goes by the name and the message, which pass between workers.
 */
export function breakdownOf(error: unknown): 'memory' | 'fault' | null;
