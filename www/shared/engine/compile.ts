/** The worker's end of the start of the page: fetches and compiles the module. */
import type { CompiledMessage } from './messages';
import { messageOf } from '../text/messages';

export async function compiled(address: string): Promise<CompiledMessage> {
  try {
    const response = await fetch(address);
    if (!response.ok) return { status: response.status, message: '' };
    // While it downloads; from its bytes where the host serves it under another media type.
    const streams = response.headers.get('content-type')?.startsWith('application/wasm') === true;
    return { compiled: streams ? await WebAssembly.compileStreaming(response) : await WebAssembly.compile(await response.arrayBuffer()) };
  } catch (error) {
    return { status: null, message: messageOf(error) };
  }
}
