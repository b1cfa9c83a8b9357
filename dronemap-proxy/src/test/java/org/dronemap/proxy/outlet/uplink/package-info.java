@NullMarked
package org.dronemap.proxy.outlet.uplink;

import org.jspecify.annotations.NullMarked;
