/**
 * The composition root: the program, its Spring configuration and its ports.
 *
 * <p>Enters: what constructs faces, and what all rooms are given.
 *
 * <p>Never: decisions of any kind.
 */
@NullMarked
package org.dronemap.ws.wiring;

import org.jspecify.annotations.NullMarked;
