/** Sign-in by an OpenID Connect provider. */
@NullMarked
package org.dronemap.ws.security.oidc;

import org.jspecify.annotations.NullMarked;
