/**
 * One program attached to the outlet: what it is shown, what waits for it, and by which system ids it knows drones.
 *
 * <p>Enters: what is kept or counted for one attached program.
 *
 * <p>Never: what its messages ask for.
 */
@NullMarked
package org.dronemap.proxy.outlet.client;

import org.jspecify.annotations.NullMarked;
