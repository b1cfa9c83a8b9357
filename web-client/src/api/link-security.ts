import type { LinkSecurityView as LinkSecurity } from '@dronemap/client';

export type { LinkSecurity };
export type { MadeLinkKey as NewLinkKey } from '@dronemap/client';

export type LinkPolicy = LinkSecurity['policy'];
