/** Links to vehicles: bytes to events, commands to bytes; {@code Proxy} is the one door. */
@NullMarked
package org.dronemap.proxy;

import org.jspecify.annotations.NullMarked;
