/**
 * This process: what it leaves behind when it ends, that it ends when it cannot do its duty, and how its parts are.
 *
 * <p>Enters: what this process does at its start and its end.
 *
 * <p>Never: the server's parts.
 */
@NullMarked
package org.dronemap.ws.process;

import org.jspecify.annotations.NullMarked;
