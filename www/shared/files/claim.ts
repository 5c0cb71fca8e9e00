/** Which tab has a project open: one at a time, told by a lock where the browser has locks, else by asking the other tabs. */

/** A tab that is just leaving lets go of its lock within this time, in ms. */
const LEAVING_MS = 1000;
/** Other tabs answer within this time, in ms. */
const ANSWER_MS = 1500;

type Message = { kind: 'ask' | 'here' | 'taken'; project: string; from: string };

/** A project that this tab has. */
export interface Claim {
  release: () => void;
}

export class Claims {
  private readonly held = new Map<string, { claim: Claim; lost: () => void }>();
  private readonly channel = typeof BroadcastChannel === 'undefined' ? null : new BroadcastChannel('tiepoint-projects');

  /** `tab` names this tab. */
  constructor(private readonly tab: string) {
    this.channel?.addEventListener('message', ({ data }: MessageEvent<Message>) => {
      if (data.from === tab || !this.held.has(data.project)) return;
      if (data.kind === 'ask') this.post('here', data.project);
      if (data.kind === 'taken') this.lose(data.project);
    });
  }

  /** Claims a project; null where another tab has it, unless it is to be taken from there. `lost`: another tab has taken it. */
  async take(project: string, steal: boolean, lost: () => void): Promise<Claim | null> {
    const held = this.held.get(project);
    if (held !== undefined) return held.claim;
    const release = await this.claimed(project, steal);
    if (release === null) return null;
    const claim: Claim = {
      release: () => {
        this.held.delete(project);
        release();
      },
    };
    this.held.set(project, { claim, lost });
    if (steal) this.post('taken', project);
    return claim;
  }

  /** Whether another tab has it open. */
  async elsewhere(project: string): Promise<boolean> {
    if (this.held.has(project)) return false;
    const release = await this.claimed(project, false);
    release?.();
    return release === null;
  }

  private lose(project: string): void {
    const held = this.held.get(project);
    held?.claim.release();
    held?.lost();
  }

  private post(kind: Message['kind'], project: string): void {
    this.channel?.postMessage({ kind, project, from: this.tab } satisfies Message);
  }

  /** What lets a project go again; null where another tab has it. */
  private claimed(project: string, steal: boolean): Promise<(() => void) | null> {
    // Absent where the page comes by plain http from another machine.
    const locks = (navigator as { locks?: LockManager }).locks;
    if (locks === undefined) return steal ? Promise.resolve(() => undefined) : this.asked(project);
    return new Promise((resolve) => {
      let granted = false;
      const how: LockOptions = steal ? { steal } : { signal: AbortSignal.timeout(LEAVING_MS) };
      locks
        .request(`tiepoint-project-${project}`, how, () => {
          granted = true;
          return new Promise<void>((release) => resolve(release));
        })
        .catch(() => {
          resolve(null);
          // A lock that was never had is not lost.
          if (granted) this.lose(project);
        });
    });
  }

  private asked(project: string): Promise<(() => void) | null> {
    const { channel } = this;
    if (channel === null) return Promise.resolve(() => undefined);
    return new Promise((resolve) => {
      const answer = (release: (() => void) | null) => {
        channel.removeEventListener('message', listen);
        resolve(release);
      };
      const listen = ({ data }: MessageEvent<Message>) => {
        if (data.kind === 'here' && data.project === project) answer(null);
      };
      channel.addEventListener('message', listen);
      this.post('ask', project);
      setTimeout(() => answer(() => undefined), ANSWER_MS);
    });
  }
}
