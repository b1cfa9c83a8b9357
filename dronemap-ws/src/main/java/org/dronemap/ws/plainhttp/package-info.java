/**
 * A page by plain HTTP on which phones learn to trust this server, and nothing else.
 *
 * <p>Enters: a page or an address that must work without TLS.
 *
 * <p>Never: anything that needs a user.
 */
@NullMarked
package org.dronemap.ws.plainhttp;

import org.jspecify.annotations.NullMarked;
