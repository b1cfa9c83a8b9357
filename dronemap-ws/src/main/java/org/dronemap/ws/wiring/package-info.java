/**
 * The composition root: the program, its Spring configuration and its ports.
 *
 * <p>Enters: what constructs use cases and faces.
 *
 * <p>Never: decisions of any kind.
 */
@NullMarked
package org.dronemap.ws.wiring;

import org.jspecify.annotations.NullMarked;
