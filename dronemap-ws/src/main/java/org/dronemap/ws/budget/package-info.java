/**
 * What each caller may cost, by kind of work, in all faces together.
 *
 * <p>Enters: a kind of work that has a bound of its own.
 *
 * <p>Never: who may do it: that is access.
 */
@NullMarked
package org.dronemap.ws.budget;

import org.jspecify.annotations.NullMarked;
