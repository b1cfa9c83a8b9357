@NullMarked
package org.dronemap.cognitive.operation.follow;

import org.jspecify.annotations.NullMarked;
