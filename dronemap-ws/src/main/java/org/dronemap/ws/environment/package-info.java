/**
 * Settings as the environment says them: read and checked once, when the server starts.
 *
 * <p>Enters: what reads and checks variables.
 *
 * <p>Never: a single setting.
 */
@NullMarked
package org.dronemap.ws.environment;

import org.jspecify.annotations.NullMarked;
