export type LinkPolicy = 'off' | 'optional' | 'required';

/** How a drone's link is secured; a key shows its fingerprint only. */
export interface LinkSecurity {
  policy: LinkPolicy;
  key: { fingerprint: string; inUse: boolean } | null;
  nextKey: string | null;
  changing: 'install' | 'rotate' | 'revoke' | null;
  /** Null: the drone has no link now. */
  safeLink: boolean | null;
  messages: {
    valid: number;
    unsigned: number;
    badSignature: number;
    replayed: number;
    tooOld: number;
    tooManyStreams: number;
  };
}

/** A key that was just made; it cannot be had again. */
export interface NewLinkKey {
  fingerprint: string;
  key: string;
}
