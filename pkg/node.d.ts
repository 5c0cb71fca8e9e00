export * from './wasm/tiepoint.js';
