/**
 * Bringing several flying drones home, or down, together: what users ask for and see.
 *
 * <p>Enters: requests, previews and views of recoveries.
 *
 * <p>Never: who comes when and at which height, which is planned elsewhere.
 */
@NullMarked
package org.dronemap.ws.recovery;

import org.jspecify.annotations.NullMarked;
