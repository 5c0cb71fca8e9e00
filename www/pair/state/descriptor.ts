/** The form of a gradient descriptor: cells a side, directions a cell, one byte each. */
export const CELLS = 4;
export const DIRECTIONS = 8;
export const DESCRIPTOR_BYTES = CELLS * CELLS * DIRECTIONS;
