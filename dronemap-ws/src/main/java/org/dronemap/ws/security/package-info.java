/**
 * Sign-in: who asks, proved by session, access key or password.
 *
 * <p>Enters: a way of proving who asks.
 *
 * <p>Never: what somebody may do: that is access.
 */
@NullMarked
package org.dronemap.ws.security;

import org.jspecify.annotations.NullMarked;
