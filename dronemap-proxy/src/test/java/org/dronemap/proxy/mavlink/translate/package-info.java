@NullMarked
package org.dronemap.proxy.mavlink.translate;

import org.jspecify.annotations.NullMarked;
