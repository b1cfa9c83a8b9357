/**
 * Sign-in by an OpenID Connect provider.
 *
 * <p>Enters: what a provider needs.
 *
 * <p>Never: users of this server alone.
 */
@NullMarked
package org.dronemap.ws.security.oidc;

import org.jspecify.annotations.NullMarked;
