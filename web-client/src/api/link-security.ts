import type { LinkSecurityView as LinkSecurity } from './contract';

export type { LinkSecurity };
export type { MadeLinkKey as NewLinkKey } from './contract';

export type LinkPolicy = LinkSecurity['policy'];
