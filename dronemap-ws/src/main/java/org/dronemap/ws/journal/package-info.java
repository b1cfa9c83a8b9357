/**
 * How states, inputs and decisions of operations are written down, and read again to the letter.
 *
 * <p>Enters: how a type is written down.
 *
 * <p>Never: what operations decide.
 */
@NullMarked
package org.dronemap.ws.journal;

import org.jspecify.annotations.NullMarked;
