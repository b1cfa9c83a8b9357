/**
 * Users: their accounts, registration, invitations, and signing in and out.
 *
 * <p>Enters: use cases about people who use the server.
 *
 * <p>Never: drones.
 */
@NullMarked
package org.dronemap.ws.user;

import org.jspecify.annotations.NullMarked;
