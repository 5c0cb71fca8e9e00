/** Addresses of scripts under Trusted Types: the content-security policy lets the page start no others. */

interface ScriptPolicy {
  createScriptURL(address: string): unknown;
}

declare const trustedTypes: { createPolicy(name: string, rules: ScriptPolicy): ScriptPolicy } | undefined;

/** The page's own files, and what it made itself. */
function own(address: string): string {
  const { origin, protocol } = new URL(address, location.href);
  if (origin !== location.origin && protocol !== 'blob:') throw new TypeError(`${address} is no script of this page`);
  return address;
}

/** The one policy that the content-security policy names; absent in browsers without Trusted Types. */
const policy = typeof trustedTypes === 'undefined' ? undefined : trustedTypes.createPolicy('tiepoint', { createScriptURL: own });

/** An address that a worker may be started from. */
export function scriptAddress(address: string): string {
  return (policy === undefined ? own(address) : policy.createScriptURL(address)) as string;
}
