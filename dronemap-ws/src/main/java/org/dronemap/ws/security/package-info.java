/** Sign-in: who asks, proved by session, access key or password. */
@NullMarked
package org.dronemap.ws.security;

import org.jspecify.annotations.NullMarked;
