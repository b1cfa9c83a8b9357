package org.dronemap.ws.http;

import java.lang.annotation.Documented;
import java.lang.annotation.ElementType;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;

/** The kinds of files that an operation takes as the body or answers with, where its signature does not say so. */
@Documented
@Retention(RetentionPolicy.RUNTIME)
@Target(ElementType.METHOD)
public @interface FileMediaTypes {
    /** Media types, any of which the body may be. */
    String[] takes() default {};

    /** Media types, one of which the answer is. */
    String[] gives() default {};
}
