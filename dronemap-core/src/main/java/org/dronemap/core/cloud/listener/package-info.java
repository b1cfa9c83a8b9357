/**
 * Listeners to the cloud, and signs that users are there.
 *
 * <p>Enters: what others hear of drones, or tell of users.
 *
 * <p>Never: what they do with it.
 */
@NullMarked
package org.dronemap.core.cloud.listener;

import org.jspecify.annotations.NullMarked;
