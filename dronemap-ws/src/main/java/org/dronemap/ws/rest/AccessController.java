package org.dronemap.ws.rest;

import io.swagger.v3.oas.annotations.Operation;
import io.swagger.v3.oas.annotations.tags.Tag;
import java.net.URI;
import java.util.List;
import org.dronemap.ws.security.CurrentPrincipal;
import org.dronemap.ws.service.AccessService;
import org.springframework.http.HttpStatus;
import org.springframework.http.ResponseEntity;
import org.springframework.web.bind.annotation.DeleteMapping;
import org.springframework.web.bind.annotation.GetMapping;
import org.springframework.web.bind.annotation.PathVariable;
import org.springframework.web.bind.annotation.PostMapping;
import org.springframework.web.bind.annotation.RequestBody;
import org.springframework.web.bind.annotation.RequestMapping;
import org.springframework.web.bind.annotation.ResponseStatus;
import org.springframework.web.bind.annotation.RestController;

/** Users and access keys. */
@RestController
@RequestMapping("/api/v1")
@Tag(name = "Access", description = "Users (for administrators) and one's own access keys for programs.")
public class AccessController {
    private final AccessService access;
    private final CurrentPrincipal current;

    /** All users. */
    public record Users(List<AccessService.UserView> users) {}

    /** All keys of the caller. */
    public record Keys(List<AccessService.KeyView> accessKeys) {}

    public AccessController(AccessService access, CurrentPrincipal current) {
        this.access = access;
        this.current = current;
    }

    @GetMapping("/users")
    @Operation(summary = "List the users (administrator)")
    public Users users() {
        return new Users(access.users(current.principal()));
    }

    @PostMapping("/users")
    @Operation(summary = "Add a user (administrator)")
    public ResponseEntity<AccessService.UserView> addUser(@RequestBody AccessService.UserRequest request) {
        AccessService.UserView user = access.addUser(current.principal(), request);
        return ResponseEntity.status(HttpStatus.CREATED).body(user);
    }

    @DeleteMapping("/users/{name}")
    @ResponseStatus(HttpStatus.NO_CONTENT)
    @Operation(summary = "Remove a user with sessions and keys (administrator)")
    public void deleteUser(@PathVariable String name) {
        access.deleteUser(current.principal(), name);
    }

    @GetMapping("/access-keys")
    @Operation(summary = "List one's own access keys")
    public Keys keys() {
        return new Keys(access.keys(current.principal()));
    }

    @PostMapping("/access-keys")
    @Operation(summary = "Make an access key", description = "The key itself is in this answer and never shown again.")
    public ResponseEntity<AccessService.KeyView> addKey(@RequestBody AccessService.AccessKeyRequest request) {
        AccessService.KeyView key = access.addKey(current.principal(), request);
        return ResponseEntity.created(URI.create("/api/v1/access-keys/" + key.id()))
                .body(key);
    }

    @DeleteMapping("/access-keys/{id}")
    @ResponseStatus(HttpStatus.NO_CONTENT)
    @Operation(summary = "Remove one of one's own access keys")
    public void deleteKey(@PathVariable String id) {
        access.deleteKey(current.principal(), id);
    }
}
