package org.dronemap.ws.http;

import java.io.IOException;
import java.time.Duration;
import org.jspecify.annotations.Nullable;
import org.springframework.core.io.Resource;
import org.springframework.http.CacheControl;
import org.springframework.web.servlet.config.annotation.ResourceHandlerRegistry;
import org.springframework.web.servlet.config.annotation.ViewControllerRegistry;
import org.springframework.web.servlet.config.annotation.WebMvcConfigurer;
import org.springframework.web.servlet.resource.PathResourceResolver;

/** Serves the web client in the browser; an address that only the client knows gets its first page. */
public final class WebClientPages implements WebMvcConfigurer {
    private static final String FILES = "classpath:/static/";

    @Override
    public void addResourceHandlers(ResourceHandlerRegistry registry) {
        registry.setOrder(1);
        // the build puts a hash of the content into these names
        registry.addResourceHandler("/assets/**")
                .addResourceLocations(FILES + "assets/")
                .setCacheControl(
                        CacheControl.maxAge(Duration.ofDays(365)).cachePublic().immutable());
        registry.addResourceHandler("/**")
                .addResourceLocations(FILES)
                .setCacheControl(CacheControl.noCache())
                .resourceChain(false)
                .addResolver(new IndexPageResolver());
    }

    @Override
    public void addViewControllers(ViewControllerRegistry registry) {
        // resource handlers never see the bare root: to them an empty path is no file
        registry.addViewController("/").setViewName("forward:/index.html");
    }

    private static final class IndexPageResolver extends PathResourceResolver {
        @Override
        protected @Nullable Resource getResource(String path, Resource location) throws IOException {
            Resource found = super.getResource(path.isEmpty() ? "index.html" : path, location);
            if (found != null || isForPrograms(path)) {
                return found;
            }
            return super.getResource("index.html", location);
        }

        private static boolean isForPrograms(String path) {
            String last = path.substring(path.lastIndexOf('/') + 1);
            return path.startsWith("api") || path.startsWith("services") || last.contains(".");
        }
    }
}
