/**
 * What was heard from a vehicle, in the words of the house.
 *
 * <p>Enters: a kind of event.
 *
 * <p>Never: what follows from it.
 */
@NullMarked
package org.dronemap.core.event;

import org.jspecify.annotations.NullMarked;
