/**
 * Following something that moves: where it is and will be, and where a drone has to be because of that.
 *
 * <p>Enters: geometry of following.
 *
 * <p>Never: commands, and the cloud.
 */
@NullMarked
package org.dronemap.cognitive.follow;

import org.jspecify.annotations.NullMarked;
