/**
 * Missions: ordered items with altitudes that carry their reference.
 *
 * <p>Enters: a kind of item, with its altitude's reference.
 *
 * <p>Never: how a vehicle is told.
 */
@NullMarked
package org.dronemap.core.mission;

import org.jspecify.annotations.NullMarked;
